package arcomat.editor.foreign;

import arcomat.check.LawBook;
import arcomat.guest.FileKind;
import arcomat.guest.Meaning;
import arcomat.guest.host.Guests;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/**
 * Files of a guest: each line, as in {@code lamp shows RED of Light}, is an output that sends one
 * message in each slice. The package is that of the folder.
 */
public final class SignFiles implements FileKind {
    /** That guest, and nobody else. */
    public static final Guests GUESTS =
            new Guests(
                    LawBook.OWN,
                    List.of(),
                    List.of(),
                    List.of(),
                    List.of(
                            new Guests.Reader(
                                    "signs", List.of(".sign"), List.of(), new SignFiles())),
                    List.of(),
                    List.of(),
                    List.of());

    private static final Pattern LINE = Pattern.compile("(\\w+) shows (\\w+) of (\\w+)");

    private SignFiles() {}

    @Override
    public List<String> endings() {
        return List.of(".sign");
    }

    @Override
    public void translate(SourceFile file, Meaning meaning) {
        Span whole = file.span(0, file.text().length());
        List<MatchResult> lines = LINE.matcher(file.text()).results().toList();
        if (lines.isEmpty()) {
            meaning.problem(whole, "a sign shows something; write 'lamp shows RED of Light'");
            return;
        }
        String[] path = file.path().replace(".sign", "").split("/");
        String folder = path[path.length - 2];
        meaning.write(whole, "package %s; import %s.Signals.*;", folder, folder);
        meaning.write(whole, "component %s { timing instant;", path[path.length - 1]);
        for (MatchResult line : lines) {
            Span port = group(file, line, 1);
            Span type = group(file, line, 3);
            meaning.write(port, "port out ").write(type, type.text()).write(port, " ");
            meaning.write(port, port.text()).write(port, ";");
        }
        meaning.write(whole, "automaton { state shown; initial shown; shown / {");
        for (MatchResult line : lines) {
            Span port = group(file, line, 1);
            Span value = group(file, line, 2);
            meaning.write(port, port.text()).write(port, " = ");
            meaning.write(value, value.text()).write(value, ";");
        }
        meaning.write(whole, "}; } }");
    }

    private static Span group(SourceFile file, MatchResult line, int number) {
        return file.span(line.start(number), line.end(number));
    }
}
