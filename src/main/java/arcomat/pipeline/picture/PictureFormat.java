package arcomat.pipeline.picture;

import arcomat.diagram.DotText;
import arcomat.diagram.Graph;
import arcomat.diagram.LayeredLayout;
import arcomat.diagram.SvgText;
import arcomat.diagram.Theme;
import arcomat.pipeline.WrongUse;
import arcomat.source.Span;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.Function;

/** How pictures are written; named as on the command line, and as files end. */
public enum PictureFormat {
    svg,
    png,
    dot;

    /**
     * A file's content.
     *
     * @param links from what is drawn to where it is written; only pictures for a browser have them
     * @throws WrongUse where the picture is too large for the format
     */
    public byte[] content(Graph graph, Function<Span, Optional<String>> links) throws WrongUse {
        return switch (this) {
            case svg -> bytes(SvgText.render(LayeredLayout.of(graph), Theme.ADAPTIVE, links));
            case png ->
                    PngImage.of(
                            SvgText.render(
                                    LayeredLayout.of(graph),
                                    Theme.LIGHT,
                                    place -> Optional.empty()));
            case dot -> bytes(DotText.render(graph));
        };
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
