package arcomat.pipeline;

/**
 * What is found where some findings were known.
 *
 * @param result about all files
 * @param checked the number of files that had to be looked at
 */
public record Recheck(CheckResult result, int checked) {
    /** Where nothing was known. */
    public static Recheck full(CheckResult result) {
        return new Recheck(result, result.files());
    }
}
