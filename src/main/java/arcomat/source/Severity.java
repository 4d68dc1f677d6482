package arcomat.source;

/** How bad a finding is. Errors fail a run; warnings do so only when asked. */
public enum Severity {
    ERROR,
    WARNING
}
