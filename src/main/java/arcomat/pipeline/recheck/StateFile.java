package arcomat.pipeline.recheck;

import arcomat.pipeline.step.PathNames;
import arcomat.report.finding.CheckState;
import arcomat.report.finding.CheckStateJson;
import arcomat.report.finding.CheckStateReader;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Optional;
import java.util.function.Function;

/**
 * The file that a check leaves behind: a digest of the rest in its first line, then the state. One
 * that is missing, damaged or written by another tool is as good as none.
 *
 * @param file as the user wrote it
 */
public record StateFile(String file, PathNames names) {

    Optional<CheckState> read(String key, Function<String, SourceFile> sources) {
        try {
            String text = Files.readString(names.resolve(file));
            int line = text.indexOf('\n');
            String state = text.substring(line + 1);
            return line >= 0 && Digest.of(state).equals(text.substring(0, line))
                    ? CheckStateReader.read(state, key, sources)
                    : Optional.empty();
        } catch (IOException missing) {
            return Optional.empty();
        }
    }

    /** What is to be written into the file. */
    public static String text(CheckState state) {
        String text = CheckStateJson.render(state);
        return Digest.of(text) + "\n" + text;
    }
}
