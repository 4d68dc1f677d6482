package arcomat.pipeline.picture;

import arcomat.diagram.DotText;
import arcomat.diagram.Graph;
import arcomat.diagram.LayeredLayout;
import arcomat.diagram.Picture;
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
     * A picture as it is written.
     *
     * @param file content of a file of its own
     * @param embedded for a page with the style sheet of pictures; empty for what is no SVG
     */
    public record Written(byte[] file, Optional<String> embedded) {}

    /**
     * A file's content.
     *
     * @param links from what is drawn to where it is written; only pictures for a browser have them
     * @throws WrongUse where the picture is too large for the format
     */
    public byte[] content(Graph graph, Function<Span, Optional<String>> links) throws WrongUse {
        return written(graph, links).file();
    }

    /** As above, and what a page shows of it. */
    public Written written(Graph graph, Function<Span, Optional<String>> links) throws WrongUse {
        return switch (this) {
            case svg -> svg(LayeredLayout.of(graph), links);
            case png ->
                    new Written(
                            PngImage.of(
                                    SvgText.render(
                                            LayeredLayout.of(graph),
                                            Theme.LIGHT,
                                            place -> Optional.empty())),
                            Optional.empty());
            case dot -> new Written(bytes(DotText.render(graph)), Optional.empty());
        };
    }

    private static Written svg(Picture picture, Function<Span, Optional<String>> links) {
        return new Written(
                bytes(SvgText.render(picture, Theme.ADAPTIVE, links)),
                Optional.of(SvgText.embedded(picture, links)));
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
