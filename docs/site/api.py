# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the API: the public headers, by subject. What each says comes from its comments, by Doxygen and Breathe."""

SUBJECTS = {
    "Interfaces of plugins": "plugin clusterer fitter relation classifier solver parameters manifest factory"
    " fingerprint",
    "Frames and files": "frame input lens scene_folder scene_path converted_scene scene_format osd_release tum_sequence bop_scene ocid_sequence labelled_cloud"
    " labelled_files pcd_header png_codec png_file"
    " depth_noise noise_calibration output_file",
    "Results of the levels": "patch_map surface_set relation_table graph segmentation role figure_ground",
    "Surfaces": "surface_model parametric_surface bspline_surface surface_modelling outline contour",
    "What relations need of a scene": "scene images boundary_lines closure hypothesised_line histogram angle wide",
    "Pipeline, config and registry": "pipeline config config_schema sensor_params surface_modelling_params"
    " figure_ground_params registry error export",
    "Learning and evaluation": "learning_set model model_fields cross_validation evaluation assignment feature_score",
    "Results as files": "result result_file",
}
REST = "Smaller things"


def slug(subject):
    return subject.lower().replace(",", "").replace(" ", "_")


def by_subject(headers):
    """Names of headers by subject; one that no subject names is under the last."""
    subjects = {subject: [name for name in names.split() if name in headers] for subject, names in SUBJECTS.items()}
    named = {name for names in subjects.values() for name in names}
    subjects[REST] = sorted(headers - named)
    return {subject: names for subject, names in subjects.items() if names}


def section(header, include):
    """What a header declares: the group that group.awk makes of its namespace, and what stands outside of that."""
    name, file = header.stem, header.relative_to(include)
    in_namespace = "\nnamespace gestalt {\n" in header.read_text()
    group = (
        f"```{{doxygengroup}} header_{name}\n:content-only:\n:members:\n:undoc-members:\n```\n\n"
        if in_namespace
        else ""
    )
    outside = "define" if in_namespace else "briefdescription detaileddescription innerclass define typedef func var"
    return f"## {file}\n\n{group}```{{doxygenfile}} {file}\n:sections: {outside}\n```\n"


def pages(includes):
    """Markdown by file name, for the headers in include folders."""
    headers = {file.stem: section(file, include) for include in includes for file in include.rglob("*.h")}
    subjects = by_subject(set(headers))
    contents = "\n".join(slug(subject) for subject in subjects)
    result = {
        "index": "# API\n\nThe public headers, `#include <gestalt/...>`; link `gestalt::core`. "
        "Lengths are metres in the camera frame, x right, y down, z forward.\n\n"
        f"```{{toctree}}\n:maxdepth: 1\n\n{contents}\n```\n"
    }
    for subject, names in subjects.items():
        sections = "\n".join(headers[name] for name in names)
        result[slug(subject)] = f"# {subject}\n\n{sections}"
    return result
