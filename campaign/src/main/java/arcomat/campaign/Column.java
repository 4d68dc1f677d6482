package arcomat.campaign;

import java.util.Arrays;
import java.util.List;

/**
 * One answer that every row of a table has.
 *
 * @param name at the head of the column
 * @param isEvent whether it is 1 or 0: it happened or it did not; else it is a number
 * @param meaning in a few words, for people
 */
public record Column(String name, boolean isEvent, String meaning) {
    /** Those that every campaign has, in the order of {@link Quantity}. */
    static List<Column> builtIn() {
        return Arrays.stream(Quantity.values())
                .map(each -> new Column(each.word(), each.isEvent(), each.meaning()))
                .toList();
    }

    /** When each level of a splitting was reached. */
    static List<Column> within(Campaign.Split split) {
        return split.columns().stream()
                .map(
                        name ->
                                new Column(
                                        name,
                                        false,
                                        "seconds until " + split.measure() + " was so"))
                .toList();
    }
}
