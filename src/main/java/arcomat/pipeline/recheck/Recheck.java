package arcomat.pipeline.recheck;

import arcomat.pipeline.check.CheckResult;

import java.util.List;

/**
 * What is found where some findings were known.
 *
 * @param result about all files
 * @param checked the files that had to be looked at
 */
public record Recheck(CheckResult result, List<String> checked) {
    public Recheck {
        checked = List.copyOf(checked);
    }

    /** Where nothing was known. */
    public static Recheck full(CheckResult result) {
        return new Recheck(result, result.paths());
    }
}
