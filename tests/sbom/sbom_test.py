# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/sbom on this build: what SPDX 2.3 demands, the versions that dpkg has, the same for every run.

Run by CTest: sbom_test.py SOURCE BUILD
"""

import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE, BUILD = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
# How each is used, and the package that must be named for it.
KNOWN = {"libeigen3-dev": "headers", "nlohmann-json3-dev": "headers", "libcli11-dev": "headers",
         "libsvm-dev": "static: libsvm.a", "libopencv-core406": "shared: libopencv_core.so",
         "libyaml-cpp0.7": "shared: libyaml-cpp.so", "libtbb12": "shared: libtbb.so", "libpng16-16": "shared: libpng16.so"}


def sbom(installed, date="1700000000"):
    return subprocess.run([SOURCE / "scripts" / "sbom", "--build", BUILD, "--installed", installed], check=True, text=True,
                          stdout=subprocess.PIPE, env={**os.environ, "SOURCE_DATE_EPOCH": date}).stdout


class Sbom(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.installed = pathlib.Path(cls.folder.name)
        subprocess.run(["cmake", "--install", BUILD, "--prefix", cls.installed, "--component", "runtime"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.text = sbom(cls.installed)
        cls.document = json.loads(cls.text)
        cls.packages = {package["name"]: package for package in cls.document["packages"]}
        cls.uses = {link["relatedSpdxElement"]: link["comment"] for link in cls.document["relationships"]
                    if link["relationshipType"] == "DEPENDS_ON" and link["spdxElementId"] == "SPDXRef-gestalt"}

    def test_document_has_what_spdx_demands(self):
        for field, value in {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT"}.items():
            self.assertEqual(self.document[field], value)
        self.assertTrue(self.document["name"])
        self.assertRegex(self.document["documentNamespace"], r"^https://[^\s#]+$")
        self.assertEqual(self.document["creationInfo"]["created"], "2023-11-14T22:13:20Z")
        for creator in self.document["creationInfo"]["creators"]:
            self.assertRegex(creator, r"^(Tool|Organization|Person): \S")

    def test_packages_and_files_have_what_spdx_demands(self):
        elements = self.document["packages"] + self.document["files"]
        for element in elements:
            self.assertRegex(element["SPDXID"], r"^SPDXRef-[A-Za-z0-9.-]+$")
        self.assertEqual(len({element["SPDXID"] for element in elements}), len(elements))
        for package in self.document["packages"]:
            self.assertTrue(package["name"])
            self.assertTrue(package["downloadLocation"])
            self.assertEqual(package["filesAnalyzed"], "packageVerificationCode" in package, package["name"])
        for file in self.document["files"]:
            self.assertRegex(file["fileName"], r"^\./[^/]")
            self.assertRegex({sum["algorithm"]: sum["checksumValue"] for sum in file["checksums"]}["SHA1"], "^[0-9a-f]{40}$")

    def test_relationships_name_elements_of_the_document(self):
        ids = {element["SPDXID"] for element in self.document["packages"] + self.document["files"]} | {"SPDXRef-DOCUMENT"}
        for link in self.document["relationships"]:
            self.assertLessEqual({link["spdxElementId"], link["relatedSpdxElement"]}, ids)
        self.assertEqual(self.document["relationships"][0]["relationshipType"], "DESCRIBES")
        self.assertEqual(set(self.uses), {package["SPDXID"] for package in self.document["packages"][1:]})

    def test_what_is_used_is_there_with_its_version(self):
        for name, use in KNOWN.items():
            package = self.packages[name]
            version, architecture = subprocess.run(["dpkg-query", "-W", "-f", "${Version} ${Architecture}\n", name], check=True,
                                                   stdout=subprocess.PIPE, text=True).stdout.splitlines()[0].split()
            self.assertEqual(package["versionInfo"], version)
            self.assertIn(use, self.uses[package["SPDXID"]])
            purl = package["externalRefs"][0]["referenceLocator"]
            self.assertTrue(purl.startswith(f"pkg:deb/debian/{name}@{version.replace('+', '%2B')}?arch={architecture}&"), purl)

    def test_what_the_inspectors_page_contains_is_there(self):
        locked = json.loads((SOURCE / "inspector/package-lock.json").read_text())["packages"]["node_modules/regl"]
        self.assertEqual(self.packages["regl"]["versionInfo"], locked["version"])
        self.assertEqual(self.packages["regl"]["licenseDeclared"], "MIT")

    def test_what_only_tests_and_benchmarks_use_is_not_there(self):
        self.assertFalse([name for name in self.packages if re.match("libgtest|libbenchmark|libvtk", name)])

    def test_licences_are_those_of_the_copyright_files(self):
        licences = {name: self.packages[name]["licenseDeclared"] for name in ("libeigen3-dev", "nlohmann-json3-dev", "libtbb12")}
        self.assertEqual(licences, {"libeigen3-dev": "MPL-2.0", "nlohmann-json3-dev": "MIT", "libtbb12": "Apache-2.0"})

    def test_own_files_have_their_digests(self):
        files = {file["fileName"]: {sum["algorithm"]: sum["checksumValue"] for sum in file["checksums"]}
                 for file in self.document["files"]}
        for name in ("./bin/gestalt", "./lib/gestalt/plugins/relation_gabor.so", "./share/gestalt/models/default.json"):
            self.assertEqual(files[name]["SHA256"], hashlib.sha256((self.installed / name).read_bytes()).hexdigest())

    def test_says_nothing_of_this_machine_and_the_same_again_but_for_the_date(self):
        for folder in (SOURCE, BUILD, self.installed):
            self.assertNotIn(str(folder), self.text)
        again = sbom(self.installed, date="1800000000")
        self.assertEqual(again.replace("2027-01-15T08:00:00Z", "2023-11-14T22:13:20Z"), self.text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
