package arcomat.analysis.smt;

import arcomat.analysis.bits.BitLetters;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Facts in bits: what is exact there, and not in linear arithmetic, are products of messages. */
final class FactBits implements FactSolver {
    private final List<DataFact> facts;
    private final BitLetters letters;

    /**
     * @param ports each with a message
     * @param stop asked now and then, whether to give up
     * @throws GivenUp where there are no bits for what ports carry
     */
    FactBits(List<Port> ports, List<DataFact> facts, BooleanSupplier stop) {
        if (ports.stream().anyMatch(port -> port.type() instanceof Type.StringType)
                || facts.stream().anyMatch(FactBits::isOpen)) {
            throw new GivenUp("linear arithmetic knows as much of texts, and sooner");
        }
        this.facts = facts;
        this.letters = new BitLetters(ports, stop);
    }

    /** Whether linear arithmetic does not do for some. */
    static boolean areFor(List<DataFact> facts) {
        return facts.stream()
                .flatMap(fact -> fact.expressions().stream())
                .anyMatch(e -> e.contains(FactBits::isNonlinear));
    }

    private static boolean isOpen(DataFact fact) {
        return fact.expressions().stream().anyMatch(e -> !BitLetters.areExact(e));
    }

    private static boolean isNonlinear(Expression e) {
        return e instanceof Expression.Binary binary
                && !ConstantExpressions.WITHOUT_NAMES.isLinear(binary);
    }

    @Override
    public void exclude(List<Optional<Value>> shown) {
        List<Integer> all = new ArrayList<>();
        for (int i = 0; i < shown.size(); i++) {
            all.add(shows(facts.get(i), shown.get(i)));
        }
        letters.claim(-letters.and(all));
    }

    private int shows(DataFact fact, Optional<Value> shown) {
        int when = letters.truth(fact.when());
        if (fact instanceof DataFact.Stored stored) {
            return shown.map(value -> letters.and(List.of(when, letters.is(stored.value(), value))))
                    .orElse(-when);
        }
        int is =
                fact instanceof DataFact.Same same
                        ? letters.and(List.of(when, letters.areSame(same.one(), same.two())))
                        : when;
        return ((Value.BooleanValue) shown.orElseThrow()).value() ? is : -is;
    }

    @Override
    public Optional<Value[]> another() {
        return letters.find();
    }

    /** All is exact, but for what divisions by zero give. */
    @Override
    public void learn(Value[] example) {
        throw new GivenUp("what divisions by zero give is not known");
    }
}
