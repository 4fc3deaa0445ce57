# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
# The command in a container:
#   docker build --tag gestalt .
#   docker run --rm --volume "$PWD:/data" gestalt segment SCENE --output out
FROM debian:12 AS build
COPY . /gestalt
WORKDIR /gestalt
RUN scripts/install_dependencies --command
RUN cmake --preset user && cmake --build --preset user && cd build && cpack

FROM debian:12
COPY --from=build /gestalt/build/packages/gestalt_*.deb /packages/
RUN apt-get update && apt-get install --yes --no-install-recommends /packages/gestalt_*.deb && rm -rf /packages /var/lib/apt/lists/*
WORKDIR /data
ENTRYPOINT ["gestalt"]
