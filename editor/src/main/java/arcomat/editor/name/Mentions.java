package arcomat.editor.name;

import arcomat.editor.desk.View;
import arcomat.pipeline.recheck.ReadModels;
import arcomat.source.SourceFile;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Occurrences;
import arcomat.symbols.occurrences.Referent;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Where things are named, in a file or in all files of its models. */
public final class Mentions {
    private Mentions() {}

    /** All names of a file, in text order; none where nothing of it can be read. */
    public static List<Occurrence> in(ReadModels models, String path) {
        return models.parsed(path)
                .flatMap(parsed -> parsed.readable())
                .map(unit -> Occurrences.of(models.workspace(), unit))
                .orElse(List.of());
    }

    public static List<Occurrence> in(View view) {
        return in(view.models(), view.file().path());
    }

    public static Optional<Occurrence> at(View view, int offset) {
        return at(view.models(), view.file().path(), offset);
    }

    /** What a cursor is in, or else what it is right behind. */
    public static Optional<Occurrence> at(ReadModels models, String path, int offset) {
        List<Occurrence> touched =
                in(models, path).stream().filter(each -> each.touches(offset)).toList();
        return touched.stream()
                .filter(each -> offset < each.span().end())
                .findFirst()
                .or(() -> touched.stream().findFirst());
    }

    /**
     * All places where something is named, file by file; that of its declaration is among them,
     * unless the name is implicit.
     */
    public static List<Occurrence> of(ReadModels models, Referent referent) {
        return withWord(models, referent.name())
                .flatMap(path -> in(models, path).stream())
                .filter(each -> each.referent().equals(referent))
                .toList();
    }

    /** The files in which a word stands, be it in a comment: it is quicker than to read them. */
    public static Stream<String> withWord(ReadModels models, String word) {
        return models.paths().stream()
                .filter(
                        path ->
                                models.source(path)
                                        .filter(source -> mentions(source, word))
                                        .isPresent());
    }

    static boolean mentions(SourceFile source, String word) {
        return nextPlace(source.text(), word, 0) >= 0;
    }

    /** Where a word begins, each time that it stands in a text. */
    static IntStream places(SourceFile source, String word) {
        return IntStream.iterate(
                nextPlace(source.text(), word, 0),
                at -> at >= 0,
                at -> nextPlace(source.text(), word, at + 1));
    }

    private static int nextPlace(String text, String word, int from) {
        for (int at = text.indexOf(word, from); at >= 0; at = text.indexOf(word, at + 1)) {
            if (isWord(text, at, at + word.length())) {
                return at;
            }
        }
        return -1;
    }

    private static boolean isWord(String text, int start, int end) {
        boolean begins = start == 0 || !Character.isJavaIdentifierPart(text.charAt(start - 1));
        boolean ends = end == text.length() || !Character.isJavaIdentifierPart(text.charAt(end));
        return begins && ends;
    }
}
