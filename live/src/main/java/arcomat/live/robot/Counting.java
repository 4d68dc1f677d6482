package arcomat.live.robot;

import arcomat.model.Value;

import java.util.Optional;
import java.util.function.Function;

/** {@code nxt.LcdNumber}: only what is new is drawn. */
final class Counting implements Part {
    private final Lettering row;
    private final String label;
    private Optional<Integer> shown = Optional.empty();

    Counting(Lettering row, String label) {
        this.row = row;
        this.label = label;
    }

    @Override
    public void begin() {
        row.show(label);
    }

    @Override
    public void act(Function<String, Optional<Value>> in) {
        Optional<Integer> number = in.apply("number").map(value -> (int) value.whole());
        if (number.isPresent() && !number.equals(shown)) {
            row.show(label, number.get());
            shown = number;
        }
    }
}
