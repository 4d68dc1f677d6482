package arcomat.live.picture;

import arcomat.diagram.Graph;
import arcomat.diagram.Picture.Box;
import arcomat.diagram.PlacedPicture;
import arcomat.diagram.SvgText;

/**
 * A picture on its way: what is to be drawn, and by which names the page's engine is asked where it
 * goes.
 */
public final class Drawing {
    private final Graph graph;
    private final Names names = new Names();

    public Drawing(Graph graph) {
        this.graph = graph;
    }

    /** What the engine is to place, as JSON. */
    public String question() {
        return LayoutQuestion.of(graph, names);
    }

    /**
     * The picture.
     *
     * @param places a line for each element, as {@link LayoutAnswer} reads them
     */
    public String svg(String places) {
        LayoutAnswer answer = LayoutAnswer.read(places, names, graph);
        Box whole = answer.whole();
        return SvgText.embedded(PlacedPicture.of(graph, whole.width(), whole.height(), answer));
    }
}
