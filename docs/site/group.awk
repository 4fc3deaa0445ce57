# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
# Doxygen's filter: what a header declares in the namespace becomes a group of its name, so that a page can show it with its
# functions, which Doxygen files under the namespace alone.
FNR == 1 { name = FILENAME; sub(/.*\//, "", name); sub(/\.h$/, "", name) }
/^}  \/\/ namespace gestalt$/ { print "/** @} */" }
{ print }
/^namespace gestalt {$/ { print "/** @addtogroup header_" name " " name ".h\n * @{ */" }
