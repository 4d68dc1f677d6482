package arcomat.live;

import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** A model of 275 lines in one file, as somebody may have written it: cells in a row. */
final class ChainModel {
    private static final int CELLS = 11;

    private static final String CELL =
            """
                /** Cell %1$d, which hands on what it gets. */
                component Cell%1$d {
                    timing instant;
                    port in Boolean own,
                         in Boolean left,
                         out Boolean right;

                    Integer seen = 0;

                    <<completion = "ignore">> automaton {
                        state dark, bright;
                        initial dark;

                        dark -> bright [seen < 5] {own == true, left == true} / {right = true, seen = seen + 1};
                        dark {own == false} / {right = false};
                        bright -> dark {left == false} / {right = false, seen = 0};
                        bright {own == true, left == true} / {right = true};
                    }
                }

                component Cell%1$d cell%1$d;
                connect button -> cell%1$d.own;
            """;

    static final String TEXT =
            """
            /**
             * Cells in a row. Each one is bright while its neighbour is, and the first one while the
             * button is pressed.
             */
            component Chain {
                timing instant;
                port in Boolean button,
                     out Boolean lamp;

            """
                    + IntStream.range(0, CELLS)
                            .mapToObj(CELL::formatted)
                            .collect(Collectors.joining("\n"))
                    + "\n    connect button -> cell0.left;\n"
                    + IntStream.range(1, CELLS)
                            .mapToObj(
                                    cell ->
                                            "    connect cell%d.right -> cell%d.left;\n"
                                                    .formatted(cell - 1, cell))
                            .collect(Collectors.joining())
                    + "    connect cell%d.right -> lamp;\n}\n".formatted(CELLS - 1);

    /** Behind the first transition of a cell in the middle. */
    static final int PLACE =
            TEXT.indexOf(";", TEXT.indexOf("dark -> bright", TEXT.indexOf("component Cell5"))) + 1;

    private ChainModel() {}
}
