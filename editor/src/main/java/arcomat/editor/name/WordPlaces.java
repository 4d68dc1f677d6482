package arcomat.editor.name;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;

/** Where a word stands in a text of whatever language. */
record WordPlaces(SourceFile file, String word) {

    /** The offsets at which it begins. */
    List<Integer> all() {
        return Mentions.places(file, word).boxed().toList();
    }

    Span span(int start) {
        return file.span(start, start + word.length());
    }

    /** Whether nothing but a qualifier, and all of it, stands in front of the word. */
    boolean isBehind(String qualifier, int start) {
        int begin = start - qualifier.length();
        return begin >= 0
                && file.text().startsWith(qualifier, begin)
                && (begin == 0 || !isOfAName(file.text().charAt(begin - 1)));
    }

    private static boolean isOfAName(char letter) {
        return letter == '.' || Character.isJavaIdentifierPart(letter);
    }

    /** Whether the word is in a comment, as worlds and campaigns have them. */
    boolean isNoted(int start) {
        int line = file.lineStart(file.position(start).line());
        return file.text().substring(line, start).indexOf('#') >= 0;
    }
}
