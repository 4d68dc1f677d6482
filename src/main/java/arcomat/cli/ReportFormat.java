package arcomat.cli;

/** How results are written that a build server reads. */
enum ReportFormat {
    text,
    json,
    sarif,
    junit,
    github
}
