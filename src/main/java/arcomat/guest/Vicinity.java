package arcomat.guest;

import arcomat.source.Span;

import java.math.BigInteger;
import java.util.List;
import java.util.Optional;

/**
 * What a behaviour finds around it, once names and types are known: a view that does not change, of
 * what it may read and write.
 *
 * @param component simple name of the one that it stands in; of one with features, a configuration
 * @param values by their names, each once: ports first, as they hide what is called the same, then
 *     variables, then parameters; inherited ones before those that are declared here
 */
public record Vicinity(String component, List<Value> values) {
    public Vicinity {
        values = List.copyOf(values);
    }

    /** What a value is to the behaviour. */
    public enum Kind {
        INPUT,
        OUTPUT,
        /**
         * Of the component: state where its behaviour writes it, and a constant where none does.
         */
        VARIABLE,
        PARAMETER
    }

    /**
     * Something that has a value.
     *
     * @param total whether a port carries a message in each slice
     * @param declared its name, where that is declared; perhaps in another file
     */
    public record Value(Kind kind, String name, Type type, boolean total, Span declared) {}

    /** Of which values a port, a variable or a parameter may have. */
    public sealed interface Type {
        /** As messages call it. */
        String name();

        /**
         * Whether a value that is written so, {@code true}, {@code clear} or {@code -3}, may be one
         * of the type: false only where it certainly is none, so that nothing is said of what is
         * not known.
         */
        boolean admits(String written);

        /** {@code Boolean} and enumerations: all values, as they are written, in their order. */
        record Choice(String name, List<String> values) implements Type {
            public Choice {
                values = List.copyOf(values);
            }

            @Override
            public boolean admits(String written) {
                return values.contains(written);
            }
        }

        /** Whole numbers, both ends included. */
        record Whole(String name, long low, long high) implements Type {
            @Override
            public boolean admits(String written) {
                if (!written.matches("-?[0-9]+")) {
                    return written.isEmpty() || !Character.isJavaIdentifierStart(written.charAt(0));
                }
                BigInteger number = new BigInteger(written);
                return number.compareTo(BigInteger.valueOf(low)) >= 0
                        && number.compareTo(BigInteger.valueOf(high)) <= 0;
            }
        }

        /**
         * Any other: fractions, texts, characters, classes, what parameters of the component stand
         * for, and what is not known because something is wrong with it, which is told elsewhere.
         */
        record Other(String name) implements Type {
            @Override
            public boolean admits(String written) {
                return true;
            }
        }
    }

    /** Those of a kind, in order. */
    public List<Value> of(Kind kind) {
        return values.stream().filter(each -> each.kind() == kind).toList();
    }

    /** What is called so. */
    public Optional<Value> value(String name) {
        return values.stream().filter(each -> each.name().equals(name)).findFirst();
    }
}
