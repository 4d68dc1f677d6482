package arcomat.pipeline.campaign.measure;

import arcomat.campaign.Measure;
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
import arcomat.world.Scene;
import arcomat.world.World;

import org.jspecify.annotations.Nullable;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** An expression that was checked, with what it reads: an input for each property of each thing. */
final class MeasuredExpression {
    private static final Value[] NO_VARIABLES = {};

    private final Measure.Fold fold;
    private final Term term;
    private final List<Port> inputs;

    private MeasuredExpression(Measure.Fold fold, Term term, List<Port> inputs) {
        this.fold = fold;
        this.term = term;
        this.inputs = inputs;
    }

    static MeasuredExpression of(Measure.Fold fold, MeasureModel.Read read) {
        Map<String, Port> inputs = new LinkedHashMap<>();
        Expression apart = read.expression().rewritten(each -> each.match(new Apart(inputs)));
        Component whole = read.component().orElseThrow();
        List<Port> properties = List.copyOf(inputs.values());
        Component reader = whole.like("reader", properties, whole.body(), whole.span());
        Term term = Evaluation.compile(apart, new Scope(reader, List.of()));
        return new MeasuredExpression(fold, term, properties);
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
    InWorld in(World world) {
        return new InWorld(
                inputs.stream().map(port -> Gauge.of(world, port.name(), port.type())).toList());
    }

    /** The expression in a world; any number of runs may ask at once. */
    final class InWorld {
        private final List<Gauge> gauges;

        private InWorld(List<Gauge> gauges) {
            this.gauges = gauges;
        }

        /** Null where it is undefined: something is missing, or it divides by zero. */
        @Nullable Value read(Scene scene, Instruments instruments) {
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

        Fold start() {
            return Fold.of(fold);
        }
    }
}
