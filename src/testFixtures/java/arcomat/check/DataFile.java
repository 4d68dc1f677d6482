package arcomat.check;

import arcomat.check.law.Profile;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Test data for a check: several model files in one, each below a line {@code //// path/Name.arc}.
 * Above the first of them stand options: {@code // profile: executable}.
 */
public record DataFile(Path path, Profile profile, List<SourceFile> files) {
    private static final String SEPARATOR = "//// ";

    public static DataFile read(Path path) throws IOException {
        List<String> header = new ArrayList<>();
        List<SourceFile> files = new ArrayList<>();
        String name = null;
        StringBuilder text = new StringBuilder();
        for (String line : Files.readString(path).split("\n", -1)) {
            if (line.startsWith(SEPARATOR)) {
                if (name != null) {
                    files.add(new SourceFile(name, text.toString()));
                }
                name = line.substring(SEPARATOR.length()).strip();
                text.setLength(0);
            } else if (name == null) {
                header.add(line);
            } else {
                text.append(line).append('\n');
            }
        }
        if (name == null) {
            throw new IllegalArgumentException(path + " has no line '//// Name.arc'");
        }
        files.add(new SourceFile(name, text.toString()));
        return new DataFile(path, profile(header), files);
    }

    private static Profile profile(List<String> header) {
        return header.contains("// profile: executable")
                ? Profile.EXECUTABLE
                : Profile.REQUIREMENTS;
    }

    /** What the comments below lines of code announce. */
    public List<Expectation> expectations() {
        List<Expectation> found = new ArrayList<>();
        for (SourceFile file : files) {
            int codeLine = 0;
            for (int line = 1; line <= file.lineCount(); line++) {
                String text = file.line(line);
                if (Expectation.isExpectation(text)) {
                    found.add(Expectation.parse(file.path(), codeLine, text));
                } else {
                    codeLine = line;
                }
            }
        }
        return found;
    }

    /** The data file with other expectations, as it would have to look to pass. */
    public String withExpectations(List<Expectation> expectations) {
        String header = profile == Profile.EXECUTABLE ? "// profile: executable\n" : "";
        return files.stream()
                .map(file -> withExpectations(file, expectations))
                .collect(Collectors.joining("\n", header, ""));
    }

    private static String withExpectations(SourceFile file, List<Expectation> expectations) {
        StringBuilder text = new StringBuilder(SEPARATOR).append(file.path()).append('\n');
        for (int line = 1; line <= file.lineCount(); line++) {
            appendLine(text, file, line, expectations);
        }
        return text.toString().stripTrailing() + "\n";
    }

    private static void appendLine(
            StringBuilder text, SourceFile file, int line, List<Expectation> expectations) {
        if (Expectation.isExpectation(file.line(line))) {
            return;
        }
        text.append(file.line(line)).append('\n');
        for (Expectation expectation : expectations) {
            if (expectation.path().equals(file.path()) && expectation.line() == line) {
                text.append(expectation.text()).append('\n');
            }
        }
    }
}
