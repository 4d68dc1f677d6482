package arcomat.pipeline.monitor;

import arcomat.pipeline.check.CheckResult;

import java.util.List;

/**
 * What came of a wish for a monitor.
 *
 * @param check with errors, nothing was written
 * @param className of the class to use
 * @param requirements what it watches for, by name and line
 * @param files paths in the output folder
 */
public record MonitorResult(
        CheckResult check, String className, List<String> requirements, List<String> files) {
    public MonitorResult {
        requirements = List.copyOf(requirements);
        files = List.copyOf(files);
    }
}
