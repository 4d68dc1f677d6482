name: models
on: [push, pull_request]
jobs:
  models:
    runs-on: ubuntu-latest
    steps:
      - uses: actions/checkout@v4
      - uses: actions/setup-java@v4
        with: { distribution: temurin, java-version: 17 }
      - uses: gradle/actions/setup-gradle@v4
        with: { gradle-version: '8.8' }
      # Checks, verifies and tests. Findings are shown beside the lines of a pull request.
      - run: gradle build checkArcFormat
