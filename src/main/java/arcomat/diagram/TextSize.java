package arcomat.diagram;

import java.util.List;

/** How much room lines of text need, in whole pixels. */
public record TextSize(double width, double height) {
    /** Between captions of one arrow. */
    static final double GAP = 5;

    /** Of lines below each other. */
    public static TextSize ofLines(List<Graph.Line> lines) {
        double width = 0;
        double height = 0;
        for (Graph.Line line : lines) {
            width = Math.max(width, line.lettering().width(line.text()));
            height += line.lettering().lineHeight();
        }
        return new TextSize(Math.ceil(width), height);
    }

    /** Below each other. */
    public static TextSize of(List<Graph.Caption> captions) {
        double width = 0;
        double height = -GAP;
        for (Graph.Caption caption : captions) {
            TextSize size = ofLines(caption.lines());
            width = Math.max(width, size.width);
            height += size.height + GAP;
        }
        return new TextSize(width, height);
    }
}
