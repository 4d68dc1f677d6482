package arcomat.pipeline.campaign.measure;

import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.expression.Term;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.world.Scene;
import arcomat.world.World;

import org.jspecify.annotations.Nullable;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** An expression that was checked, with what it reads: an input for each property of each thing. */
public final class MeasuredExpression {
    private static final Value[] NO_VARIABLES = {};

    private final Type type;
    private final Term term;
    private final List<Port> inputs;

    private MeasuredExpression(Type type, Term term, List<Port> inputs) {
        this.type = type;
        this.term = term;
        this.inputs = inputs;
    }

    /**
     * What became of what was written.
     *
     * @param expression absent where there are findings
     * @param findings at their places in the campaign
     */
    public record Reading(Optional<MeasuredExpression> expression, List<Diagnostic> findings) {}

    /**
     * Reads an expression.
     *
     * @param written in the campaign
     * @param type that it is to have, as models write it: of those that need no import
     */
    public static Reading read(Span written, String type, Vocabulary vocabulary) {
        MeasureModel.Read read = MeasureModel.read(written, type, vocabulary);
        return new Reading(
                read.component().map(each -> of(each, read.expression())), read.findings());
    }

    private static MeasuredExpression of(Component whole, Expression expression) {
        Map<String, Port> inputs = new LinkedHashMap<>();
        Expression apart = expression.rewritten(each -> each.match(new Apart(inputs)));
        List<Port> properties = List.copyOf(inputs.values());
        Component reader = whole.like("reader", properties, whole.body(), whole.span());
        Term term = Evaluation.compile(apart, new Scope(reader, List.of()));
        return new MeasuredExpression(whole.outputs().get(0).type(), term, properties);
    }

    /** What values it is to have: those that it has may lie outside of its range. */
    public Type type() {
        return type;
    }

    /** What an object's attribute was is an input of its own: only that is read. */
    private record Apart(Map<String, Port> inputs) implements Expression.SomeCases<Expression> {
        @Override
        public Expression portRead(Expression.PortRead read) {
            boolean whole = read.type() instanceof Type.ClassType;
            return whole ? read : input(read.port().name(), read.type(), read);
        }

        @Override
        public Expression attributeRead(Expression.AttributeRead read) {
            Expression.PortRead object = (Expression.PortRead) read.object();
            Type.ClassType type = (Type.ClassType) object.type();
            String name = object.port().name() + "." + type.attributes().get(read.index()).name();
            return input(name, read.type(), object);
        }

        private Expression input(String name, Type type, Expression.PortRead place) {
            Port port =
                    inputs.computeIfAbsent(
                            name,
                            each ->
                                    new Port(
                                            each,
                                            Port.Direction.IN,
                                            type,
                                            false,
                                            0,
                                            false,
                                            place.port().span()));
            return new Expression.PortRead(port, place.span());
        }

        @Override
        public Expression otherwise(Expression expression) {
            return expression;
        }
    }

    /** It is told of this world; what the world does not have is undefined. */
    public InWorld in(World world) {
        return new InWorld(
                inputs.stream().map(port -> Gauge.of(world, port.name(), port.type())).toList());
    }

    /** The expression in a world; any number of runs may ask at once. */
    public final class InWorld {
        private final List<Gauge> gauges;

        private InWorld(List<Gauge> gauges) {
            this.gauges = gauges;
        }

        /** Null where it is undefined: something is missing, or it divides by zero. */
        public @Nullable Value read(Scene scene, Instruments instruments) {
            Value[] ports = new Value[gauges.size()];
            for (int i = 0; i < ports.length; i++) {
                ports[i] = gauges.get(i).read(scene, instruments);
            }
            try {
                return term.evaluate(ports, NO_VARIABLES);
            } catch (Fault e) {
                return null;
            }
        }

        /** Whether the world has all that it reads. */
        public boolean isWhole() {
            return !gauges.contains(Gauge.NOTHING);
        }
    }
}
