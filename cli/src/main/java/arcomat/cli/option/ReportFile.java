package arcomat.cli.option;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

import java.util.Optional;

/**
 * A report to be written beside what is printed: {@code FORMAT=FILE}, or {@code DIR} for a page.
 *
 * @param format of the tool or of a guest; empty for a page
 * @param file the file, or the folder of the page
 */
record ReportFile(Optional<String> format, String file) {

    /** Reads {@code FORMAT=FILE}. */
    static final class Reader implements ITypeConverter<ReportFile> {
        @Override
        public ReportFile convert(String written) {
            int equals = written.indexOf('=');
            if (equals < 0 || equals == written.length() - 1) {
                throw new TypeConversionException(
                        "'" + written + "' is not FORMAT=FILE, as in junit=build/results.xml");
            }
            String name = written.substring(0, equals);
            return new ReportFile(Optional.of(name), written.substring(equals + 1));
        }
    }

    /** Reads {@code DIR} as well. */
    static final class ReaderOfPages implements ITypeConverter<ReportFile> {
        @Override
        public ReportFile convert(String written) {
            // Whoever writes only a format has forgotten the file.
            boolean folder = written.indexOf('=') < 0 && !written.isEmpty();
            return folder && ReportFormat.of(written).isEmpty()
                    ? new ReportFile(Optional.empty(), written)
                    : new Reader().convert(written);
        }
    }
}
