package arcomat.analysis.smt;

import arcomat.analysis.reachability.Logic.Answer;
import arcomat.model.Expression;
import arcomat.model.ExpressionText;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.SmallType;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;

/** Facts in linear arithmetic: what it cannot say is an unknown value, about which it may learn. */
final class FactTerms implements FactSolver {
    /** So often the solver is told of products. */
    private static final int LESSONS = 40;

    private final List<Port> ports;
    private final List<DataFact> facts;
    private final Solver solver;
    private final Encoding codes;
    private final LetterInputs inputs;
    private final Translation translation;
    private final Scope scope;
    private int lessons;
    private List<Term> lesson = List.of();

    /** What the solver gave another value than it has. */
    private Optional<Expression> blamed = Optional.empty();

    /**
     * @param ports each with a message
     * @param stop asked now and then, whether to give up
     */
    FactTerms(List<Port> ports, List<DataFact> facts, BooleanSupplier stop) {
        this.ports = ports;
        this.facts = facts;
        this.scope = Scope.ofPorts(ports);
        this.solver = new Solver(stop);
        this.codes = new Encoding(solver, true);
        this.inputs = new LetterInputs(solver, codes);
        this.translation =
                new Translation(ConstantExpressions.WITHOUT_NAMES, inputs, solver, codes);
        for (Port port : ports) {
            solver.claim(codes.range(inputs.message(port), port.type()));
        }
    }

    @Override
    public void exclude(List<Optional<Value>> shown) {
        List<Term> agree = new ArrayList<>();
        for (int i = 0; i < shown.size(); i++) {
            agree.add(agrees(facts.get(i), shown.get(i)));
        }
        solver.claim(solver.not(solver.and(agree)));
    }

    private Term agrees(DataFact fact, Optional<Value> shown) {
        Term when = translation.term(fact.when());
        if (fact instanceof DataFact.Stored stored) {
            return shown.map(value -> solver.and(when, is(stored.value(), value)))
                    .orElseGet(() -> solver.not(when));
        }
        Term term =
                fact instanceof DataFact.Same same
                        ? solver.and(when, isSame(same.one(), same.two()))
                        : when;
        return ((Value.BooleanValue) shown.orElseThrow()).value() ? term : solver.not(term);
    }

    private Term is(Expression e, Value value) {
        if (!codes.isExact(e.type())) {
            throw undecided(e);
        }
        return solver.equal(translation.term(e), codes.encode(value, e.type()));
    }

    /** Whether they are the same message. */
    private Term isSame(Expression one, Expression two) {
        boolean comparable =
                codes.isExact(one.type()) && one.type().getClass() == two.type().getClass();
        if (!comparable) {
            throw undecided(one instanceof Expression.Constant ? two : one);
        }
        return solver.equal(translation.term(one), translation.term(two));
    }

    @Override
    public Optional<Value[]> another() {
        List<Value[]> found = new ArrayList<>();
        Answer answer =
                lesson.isEmpty() ? Answer.NO : solver.assuming(lesson, () -> found.add(messages()));
        lesson = List.of();
        if (answer != Answer.YES) {
            answer = solver.assuming(List.of(), () -> found.add(messages()));
        }
        return switch (answer) {
            case YES -> Optional.of(found.get(0));
            case NO -> Optional.empty();
            case UNKNOWN -> throw inexact();
        };
    }

    private Value[] messages() {
        Value[] row = ports.stream().map(this::message).toArray(Value[]::new);
        blamed = Optional.empty();
        translation
                .replaced()
                .forEach(
                        (e, term) -> {
                            if (blamed.isEmpty() && !isRight(e, term, row)) {
                                blamed = Optional.of(e);
                            }
                        });
        return row;
    }

    private boolean isRight(Expression e, Term term, Value[] row) {
        Value really;
        try {
            really = scope.value(e, row);
        } catch (Fault divisionByZero) {
            return true; // nobody asks for what it gives
        }
        return codes.isExact(e.type()) && codes.decode(term, e.type()).equals(really);
    }

    private Value message(Port port) {
        return codes.decode(inputs.message(port), port.type());
    }

    /** Tells the solver of the products that it got wrong, but not for ever. */
    @Override
    public void learn(Value[] example) {
        lesson = ++lessons > LESSONS ? List.of() : translation.learn(scope, example);
        if (lesson.isEmpty()) {
            throw inexact();
        }
    }

    /** The solver does not get on: because of what it does not know, if there is such a thing. */
    GivenUp inexact() {
        return blamed.map(FactTerms::undecided)
                .orElseGet(
                        () -> new GivenUp("the solver gave up on " + named(ports) + advice(ports)));
    }

    private static GivenUp undecided(Expression e) {
        return new GivenUp(
                "what '%s' gives cannot be put exactly to the solver%s"
                        .formatted(ExpressionText.of(e), advice(e.ports())));
    }

    /** More ways to differ than are tried. */
    static GivenUp tooMany(List<Port> ports) {
        return new GivenUp(
                "guards tell more than %d kinds of messages on %s apart"
                        .formatted(MessageExamples.MOST, named(ports)));
    }

    /** More values are stored than are tried. */
    static GivenUp tooManyStored(DataFact.Stored fact) {
        return new GivenUp(
                "'%s' is stored, and has too many values to try%s"
                        .formatted(ExpressionText.of(fact.value()), advice(fact.value().ports())));
    }

    private static String advice(List<Port> ports) {
        List<Port> wide =
                ports.stream()
                        .distinct()
                        .filter(port -> port.type() instanceof Type.IntegerType)
                        .filter(port -> SmallType.values(port.type()).isEmpty())
                        .toList();
        return wide.isEmpty()
                ? ""
                : "; give %s a range of at most %d values".formatted(named(wide), SmallType.MOST);
    }

    private static String named(List<Port> ports) {
        return ports.stream()
                .map(port -> "'" + port.name() + "'")
                .collect(Collectors.joining(" and "));
    }
}
