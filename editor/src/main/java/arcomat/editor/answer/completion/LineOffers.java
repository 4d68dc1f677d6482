package arcomat.editor.answer.completion;

import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.BesideText.Choice;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;

/**
 * What could be written at a place of a world, a campaign or a script: names and words, and at the
 * beginning of a line whole pieces.
 *
 * @param typed the word that is being typed: names have dots, dashes and dollars
 */
public record LineOffers(Span typed, List<Choice> choices, List<Skeleton> pieces) {
    public LineOffers {
        choices = List.copyOf(choices);
        pieces = List.copyOf(pieces);
    }

    /**
     * @param file the text as it is on the screen
     * @param choices that the text has there
     */
    public static LineOffers at(SourceFile file, int offset, List<Choice> choices) {
        SourceFile before = BesideText.before(file, offset);
        boolean isAlone = (before.text() + file.text().substring(offset)).isBlank();
        return new LineOffers(
                file.span(before.text().length(), offset),
                choices,
                BesideText.lastLine(before).isEmpty()
                        ? LineSkeleton.fitting(file.path(), isAlone, choices)
                        : List.of());
    }
}
