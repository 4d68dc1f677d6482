package arcomat.cli;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

import java.util.Arrays;
import java.util.stream.Collectors;

/** {@code FORMAT=FILE}: a report to be written beside what is printed. */
record ReportFile(ReportFormat format, String file) {

    /** Reads what the user wrote. */
    static final class Reader implements ITypeConverter<ReportFile> {
        @Override
        public ReportFile convert(String written) {
            int equals = written.indexOf('=');
            if (equals < 0 || equals == written.length() - 1) {
                throw new TypeConversionException(
                        "'" + written + "' is not FORMAT=FILE, as in junit=build/results.xml");
            }
            return new ReportFile(
                    format(written.substring(0, equals)), written.substring(equals + 1));
        }

        private static ReportFormat format(String name) {
            return Arrays.stream(ReportFormat.values())
                    .filter(each -> each.name().equals(name))
                    .findFirst()
                    .orElseThrow(
                            () ->
                                    new TypeConversionException(
                                            "there is no format '" + name + "', only " + all()));
        }

        private static String all() {
            return Arrays.stream(ReportFormat.values())
                    .map(ReportFormat::name)
                    .collect(Collectors.joining(", "));
        }
    }
}
