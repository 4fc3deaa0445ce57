# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
function(run expected)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE code)
  if(NOT code EQUAL 0 OR NOT out MATCHES "${expected}")
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nexit code ${code}, expected 0 and '${expected}' in:\n${out}")
  endif()
endfunction()

set(gestalt ${BUILD}/bin/gestalt)
set(example ${SOURCE}/examples/support_height)
file(REMOVE_RECURSE ${WORK}/build ${WORK}/scenes)
run("" ${CMAKE_COMMAND} -S ${example} -B ${WORK}/build -DGestalt_DIR=${BUILD})
run("" ${CMAKE_COMMAND} --build ${WORK}/build)

set(with_plugin ${CMAKE_COMMAND} -E env GESTALT_PLUGIN_PATH=${WORK}/build/plugins ${gestalt})
run("support_height" ${with_plugin} plugins list)
run("highest: real" ${with_plugin} plugins describe support_height)
run("" ${gestalt} synthesize --category mixed_objects --seed 11 --count 4 --output ${WORK}/scenes)
run("r_sh" ${with_plugin} train ${WORK}/scenes --config ${example}/config.yaml --output ${WORK}/model.json)
run("balanced error" ${with_plugin} evaluate ${WORK}/scenes --cross-validate 2 --all --config ${example}/config.yaml)
run("balanced error" ${with_plugin} evaluate ${WORK}/scenes --cross-validate 2 --all --config ${example}/config.yaml --set
    structural.relations.support_height=off)
