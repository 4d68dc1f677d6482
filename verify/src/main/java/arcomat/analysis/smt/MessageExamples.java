package arcomat.analysis.smt;

import arcomat.analysis.bits.Thresholds;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.PartialEvaluation;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.expression.Term;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * Messages for some ports at once, of types that have too many values to try: one example for each
 * way in which facts can be so or not (the minterms of D'Antoni, Veanes, "Minimization of symbolic
 * automata", POPL 2014). What an example shows is computed as the interpreter does; that there is
 * no other one, is proved by the solver.
 */
public final class MessageExamples {
    /** As many ways are told apart; of a value that is stored, each is one. */
    static final int MOST = 200;

    /** So many values of what is stored are tried. */
    private static final int MOST_STORED = 24;

    /** As many are tried where these are not all. */
    private static final int SOME = 16;

    private static final Value[] NO_VARIABLES = {};

    /** What an example shows of a fact: a truth value, or a value that is stored. */
    private interface Look {
        Optional<Value> at(Value[] example);
    }

    private final List<Port> ports;
    private final List<DataFact> facts;
    private final BooleanSupplier stop;
    private final List<Look> looks;
    private final List<Value[]> examples = new ArrayList<>();
    private final Set<List<Optional<Value>>> met = new HashSet<>();

    private MessageExamples(List<Port> ports, List<DataFact> facts, BooleanSupplier stop) {
        this.ports = ports;
        this.facts = facts.stream().map(fact -> fact.with(Thresholds::simplified)).toList();
        this.stop = stop;
        Scope scope = Scope.ofPorts(ports);
        this.looks = facts.stream().map(fact -> look(fact, scope)).toList();
    }

    /** Messages for open ports, where others are known. */
    public interface Source {
        /**
         * Messages for each way in which steps differ.
         *
         * @param letter what is known of the letter
         * @param open the ports, each with a message
         */
        Rows of(PartialEvaluation letter, List<Port> open);
    }

    /**
     * Messages by position of the port.
     *
     * @param missing why there may be other ways in which steps differ: what is to blame and what
     *     would help; empty where these are all
     */
    public record Rows(List<Value[]> rows, Optional<String> missing) {
        public Rows {
            rows = List.copyOf(rows);
        }
    }

    /**
     * Examples for open ports, about which there are facts.
     *
     * @param stop asked now and then, whether to give up
     */
    static Rows of(List<Port> open, List<DataFact> facts, BooleanSupplier stop) {
        return new MessageExamples(open, facts, stop).found();
    }

    private static Look look(DataFact fact, Scope scope) {
        Term when = Evaluation.compile(fact.when(), scope);
        if (fact instanceof DataFact.Same same) {
            Term one = Evaluation.compile(same.one(), scope);
            Term two = Evaluation.compile(same.two(), scope);
            return row ->
                    truth(when.holds(row, NO_VARIABLES) && value(one, row).equals(value(two, row)));
        }
        if (fact instanceof DataFact.Stored stored) {
            Term value = Evaluation.compile(stored.value(), scope);
            return row ->
                    when.holds(row, NO_VARIABLES)
                            ? Optional.of(value(value, row))
                            : Optional.empty();
        }
        return row -> truth(when.holds(row, NO_VARIABLES));
    }

    private static Optional<Value> truth(boolean value) {
        return Optional.of(new Value.BooleanValue(value));
    }

    private static Value value(Term term, Value[] row) {
        return Objects.requireNonNull(term.evaluate(row, NO_VARIABLES));
    }

    private boolean add(Value[] row) {
        boolean fresh = met.add(shown(row));
        if (fresh) {
            examples.add(row);
        }
        return fresh;
    }

    private List<Optional<Value>> shown(Value[] row) {
        return looks.stream().map(look -> look.at(row)).toList();
    }

    private Rows found() {
        for (Value[] row : new SmallExamples(ports, facts).rows()) {
            add(row);
        }
        try {
            settle();
            return new Rows(examples, Optional.empty());
        } catch (GivenUp reason) {
            return new Rows(some(), Optional.of(String.valueOf(reason.getMessage())));
        }
    }

    /**
     * Some of many: all ways in which conditions are true or not, if they can be told, and then
     * others. Which values are stored is left aside at first, since there may be any number.
     */
    private List<Value[]> some() {
        List<Value[]> some = new ArrayList<>(withoutStored());
        int room = Math.max(0, SOME - some.size());
        some.addAll(examples.subList(0, Math.min(room, examples.size())));
        return some;
    }

    private List<Value[]> withoutStored() {
        return facts.stream().anyMatch(MessageExamples::storesObject)
                ? of(ports, facts.stream().map(MessageExamples::withoutStored).toList(), stop).rows
                : List.of();
    }

    /** Numbers are told apart near to what conditions mention before solvers are asked. */
    private static boolean storesObject(DataFact fact) {
        return fact instanceof DataFact.Stored stored
                && stored.value().type() instanceof Type.ClassType;
    }

    private static DataFact withoutStored(DataFact fact) {
        return fact instanceof DataFact.Stored stored ? new DataFact.Holds(stored.when()) : fact;
    }

    /** What bits are better for, they are asked about first, and about the rest last. */
    private void settle() {
        boolean bitsFirst = FactBits.areFor(facts);
        if (bitsFirst && isSettledInBits()) {
            return;
        }
        try {
            insist();
            settle(new FactTerms(ports, facts, stop));
        } catch (GivenUp reason) {
            if (bitsFirst || !isSettledInBits()) {
                throw reason;
            }
        }
    }

    private boolean isSettledInBits() {
        try {
            insist();
            settle(new FactBits(ports, facts, stop));
            return true;
        } catch (GivenUp hard) {
            return false;
        }
    }

    /** Until there is no further way in which facts can be so or not. */
    private void settle(FactSolver solver) {
        met.forEach(solver::exclude);
        Optional<Value[]> next = solver.another();
        while (next.isPresent()) {
            if (add(next.get())) {
                solver.exclude(shown(next.get()));
                insist();
            } else {
                solver.learn(next.get());
            }
            next = solver.another();
        }
    }

    private void insist() {
        for (int i = 0; i < facts.size(); i++) {
            int fact = i;
            boolean stored = facts.get(i) instanceof DataFact.Stored;
            if (stored
                    && met.stream().map(each -> each.get(fact)).distinct().count() > MOST_STORED) {
                throw FactTerms.tooManyStored((DataFact.Stored) facts.get(i));
            }
        }
        if (examples.size() > MOST) {
            throw FactTerms.tooMany(ports);
        }
    }
}
