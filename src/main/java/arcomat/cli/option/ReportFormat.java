package arcomat.cli.option;

/** How results are written that a build server reads. */
public enum ReportFormat {
    text,
    json,
    sarif,
    junit,
    github
}
