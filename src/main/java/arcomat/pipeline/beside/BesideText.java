package arcomat.pipeline.beside;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** A text beside models: a world, a campaign, a script. */
public interface BesideText {
    /** What a command would find that reads it; less where that would take long. */
    List<Diagnostic> findings();

    /** What its words stand for, as far as that is written elsewhere. */
    List<Link> links();

    /**
     * What may stand at a place: words of the language, and names that are known; nothing where it
     * is a number, or a name that is to be made up.
     */
    List<Choice> choices(int offset);

    /**
     * A word that may stand at a place.
     *
     * @param what it is, where it is a name; empty for words of the language
     */
    record Choice(String word, String what) {
        /** Whether it is a word of the language. */
        public boolean isWord() {
            return what.isEmpty();
        }

        /** Words of the language. */
        public static List<Choice> words(List<String> words) {
            return words.stream().map(word -> new Choice(word, "")).toList();
        }
    }

    /**
     * From a word to what it stands for.
     *
     * @param target empty for the whole file
     */
    record Link(Span from, Path file, Optional<Span> target) {}

    /** The text in front of the word at a place. */
    static SourceFile before(SourceFile text, int offset) {
        int start = offset;
        while (start > 0 && !Character.isWhitespace(text.text().charAt(start - 1))) {
            start--;
        }
        return new SourceFile(text.path(), text.text().substring(0, start));
    }

    /** The words of the last line of a text. */
    static List<String> lastLine(SourceFile text) {
        String line = text.line(text.lineCount());
        return line.isBlank() ? List.of() : List.of(line.strip().split("\\s+"));
    }
}
