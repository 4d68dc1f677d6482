package arcomat.campaign;

import arcomat.source.Span;
import arcomat.world.Word;
import arcomat.world.Words;
import arcomat.world.Words.Unreadable;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * A column that a campaign defines: what an expression comes to over a run.
 *
 * @param name of the column
 * @param expression in the language of the models, over what can be read in a world
 * @param place where the campaign names it
 */
public record Measure(String name, Fold fold, Span expression, Span place) {
    /** How what an expression is at each moment becomes one number. */
    public enum Fold {
        LARGEST(false, true),
        SMALLEST(false, true),
        /** Of all moments alike. */
        MEAN(false, true),
        /** When the run was over. */
        LAST(false, true),
        /** How long it was true, in seconds. */
        SECONDS(false, false),
        /** Whether it was true at some moment. */
        WHEN(true, false);

        private final boolean event;
        private final boolean number;

        Fold(boolean event, boolean number) {
            this.event = event;
            this.number = number;
        }

        /** Whether the column says that something happened; else it has a number. */
        boolean isEvent() {
            return event;
        }

        /** Whether it is told of a number; else of a condition. */
        public boolean isOfNumber() {
            return number;
        }

        /** As a campaign writes it. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }

        private static List<String> words() {
            return Arrays.stream(values()).filter(each -> !each.event).map(Fold::word).toList();
        }
    }

    private static final String EXPRESSION = "an expression over what can be read in the world";

    /** {@code measure NAME FOLD EXPRESSION}, behind its first word. */
    static Measure number(Words words) throws Unreadable {
        Word name = columnName(words);
        String fold = words.choice("how it becomes one number", Fold.words()).text();
        Fold way = Fold.valueOf(fold.toUpperCase(Locale.ROOT));
        return new Measure(name.text(), way, words.rest(EXPRESSION), name.place());
    }

    /** {@code event NAME when EXPRESSION}, behind its first word. */
    static Measure event(Words words) throws Unreadable {
        Word name = columnName(words);
        words.expect(Fold.WHEN.word());
        return new Measure(name.text(), Fold.WHEN, words.rest(EXPRESSION), name.place());
    }

    /** Whatever columns are called stands in demands, where numbers have a meaning of their own. */
    static Word columnName(Words words) throws Unreadable {
        Word name = words.next("a name for the column");
        if (!name.text().matches("[A-Za-z][A-Za-z0-9_-]*")) {
            throw words.wrong(
                    name,
                    "'%s' is no name: a letter, then letters, digits, - and _"
                            .formatted(name.text()));
        }
        return name;
    }

    Column column() {
        String shown = expression.text().strip();
        return new Column(name, fold.isEvent(), fold.isEvent() ? shown : fold.word() + " " + shown);
    }
}
