package arcomat.report;

/** A model whose result pages are tested. */
final class DoorModel {
    static final String DOOR =
            """
            component Door {
              timing instant;
              port in Boolean button, out Boolean open;
              <<completion = "ignore">> automaton {
                variable Integer[0..9] left = 0;
                state closed, opened;
                initial closed;
                closed -> opened {button == true} / {open = true, left = 2};
                opened [left > 0] / {left = left - 1};
                opened -> closed [left == 0] / {open = false};
              }
            }
            """;

    private DoorModel() {}
}
