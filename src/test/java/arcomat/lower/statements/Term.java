package arcomat.lower.statements;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * An expression with what it means among statements.
 *
 * @param text as models write it
 */
record Term(String text, Function<Frame, Deferred> meaning) {

    static Term constant(Object value) {
        return new Term(String.valueOf(value), frame -> Deferred.of(value));
    }

    static Term name(String name) {
        return new Term(name, frame -> frame.value(name));
    }

    static Term silence(String port, boolean isSilent, String sign) {
        return new Term(
                "(" + port + (isSilent ? " == " : " != ") + sign + ")",
                frame -> Deferred.of(frame.message(port).isEmpty() == isSilent));
    }

    static Term calculated(
            Term left, String operator, Term right, BiFunction<Integer, Integer, Object> value) {
        return new Term(
                "(" + left.text + " " + operator + " " + right.text + ")",
                frame -> {
                    Deferred a = left.in(frame);
                    Deferred b = right.in(frame);
                    return new Deferred(
                            both(a, b),
                            () -> a.isDefined().getAsBoolean() && b.isDefined().getAsBoolean(),
                            () -> value.apply(a.number(), b.number()));
                });
    }

    static Term not(Term term) {
        return new Term(
                "!" + term.text,
                frame -> {
                    Deferred a = term.in(frame);
                    return new Deferred(a.reads(), a.isDefined(), () -> !a.truth().orElseThrow());
                });
    }

    /** Kleene's: the first operand may decide, and so may the second. */
    static Term either(Term left, Term right) {
        return lazy(left, "||", right, true);
    }

    static Term both(Term left, Term right) {
        return lazy(left, "&&", right, false);
    }

    private static Term lazy(Term left, String operator, Term right, boolean decides) {
        return new Term(
                "(" + left.text + " " + operator + " " + right.text + ")",
                frame -> {
                    Deferred a = left.in(frame);
                    Deferred b = right.in(frame);
                    Supplier<Optional<Boolean>> truth = () -> lazy(a, b, decides);
                    return new Deferred(
                            both(a, b),
                            () -> truth.get().isPresent(),
                            () -> truth.get().orElseThrow());
                });
    }

    private static Optional<Boolean> lazy(Deferred a, Deferred b, boolean decides) {
        Optional<Boolean> first = a.truth();
        if (first.equals(Optional.of(decides))) {
            return first;
        }
        Optional<Boolean> second = b.truth();
        if (second.equals(Optional.of(decides))) {
            return second;
        }
        return first.isEmpty() ? first : second;
    }

    static Term chosen(Term condition, Term then, Term otherwise) {
        return new Term(
                "(if %s then %s else %s)".formatted(condition.text, then.text, otherwise.text),
                frame -> {
                    Deferred c = condition.in(frame);
                    Deferred a = then.in(frame);
                    Deferred b = otherwise.in(frame);
                    Set<String> reads = both(a, b);
                    reads.addAll(c.reads());
                    return new Deferred(
                            reads,
                            () ->
                                    c.truth()
                                            .map(each -> each ? a : b)
                                            .filter(each -> each.isDefined().getAsBoolean())
                                            .isPresent(),
                            () -> (c.truth().orElseThrow() ? a : b).value().get());
                });
    }

    private static Set<String> both(Deferred a, Deferred b) {
        Set<String> reads = new HashSet<>(a.reads());
        reads.addAll(b.reads());
        return reads;
    }

    Deferred in(Frame frame) {
        return meaning.apply(frame);
    }
}
