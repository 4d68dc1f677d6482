package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.MessageClasses;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * Messages that are easy to read, tried before a solver is asked: the first values of types, and
 * those near to what facts mention. They settle most of what there is to tell apart.
 */
record SmallExamples(List<Port> ports, List<DataFact> facts) {
    private static final int ROWS = 2_000;
    private static final int BESIDE = 2;
    private static final Ends ENDS = new Ends();

    List<Value[]> rows() {
        List<List<Value>> columns = ports.stream().map(port -> values(port.type())).toList();
        List<Value[]> rows = new ArrayList<>();
        rows.add(new Value[ports.size()]);
        int width = Math.max(2, (int) Math.pow(ROWS, 1.0 / Math.max(1, ports.size())));
        for (int port = 0; port < ports.size() && rows.size() <= ROWS; port++) {
            List<Value[]> longer = new ArrayList<>();
            for (Value value :
                    columns.get(port).subList(0, Math.min(width, columns.get(port).size()))) {
                for (Value[] row : rows) {
                    Value[] copy = row.clone();
                    copy[port] = value;
                    longer.add(copy);
                }
            }
            rows = longer;
        }
        return rows.get(0).length > 0 && rows.get(0)[ports.size() - 1] == null ? List.of() : rows;
    }

    private List<Value> values(Type type) {
        Set<Value> values = new LinkedHashSet<>();
        values.add(type.first());
        if (type instanceof Type.IntegerType integer) {
            mentioned().forEach(value -> beside(integer, value, values));
            for (long number : new long[] {1, -1, 2, integer.high(), integer.low()}) {
                add(integer, number, values);
            }
        } else if (type instanceof Type.RealType real) {
            reals(real).filter(type::has).forEach(values::add);
        } else {
            mentioned().stream().filter(type::has).forEach(values::add);
            values.addAll(type.match(ENDS));
        }
        return List.copyOf(values);
    }

    /** Where rounding begins, too: next to what is mentioned, and at the ends of all numbers. */
    private Stream<Value> reals(Type.RealType type) {
        double end = Double.POSITIVE_INFINITY;
        DoubleStream all = DoubleStream.of(1, type.above(0), end, type.below(end));
        DoubleStream mentioned = mentioned().stream().flatMapToDouble(value -> beside(value, type));
        return DoubleStream.concat(
                        DoubleStream.concat(mentioned, all).flatMap(d -> DoubleStream.of(d, -d)),
                        DoubleStream.of(Double.NaN, -0.0))
                .mapToObj(Value.RealValue::new);
    }

    private static DoubleStream beside(Value value, Type.RealType type) {
        if (value instanceof Value.RealValue real) {
            double number = real.value();
            return DoubleStream.of(number, type.above(number), type.below(number));
        }
        return value instanceof Value.IntegerValue whole
                ? DoubleStream.of((double) whole.value())
                : DoubleStream.empty();
    }

    private static void beside(Type.IntegerType type, Value value, Set<Value> values) {
        if (value instanceof Value.IntegerValue integer) {
            add(type, integer.value(), values);
            for (int distance = 1; distance < BESIDE; distance++) {
                add(type, integer.value() + distance, values);
                add(type, integer.value() - distance, values);
            }
        }
    }

    private static void add(Type.IntegerType type, long number, Set<Value> values) {
        Value value = new Value.IntegerValue(number);
        if (MessageClasses.isIn(type, value)) {
            values.add(value);
        }
    }

    private Set<Value> mentioned() {
        Set<Value> mentioned = new LinkedHashSet<>();
        for (DataFact fact : facts) {
            collect(fact.when(), mentioned);
            if (fact instanceof DataFact.Same same) {
                collect(same.one(), mentioned);
                collect(same.two(), mentioned);
            } else if (fact instanceof DataFact.Stored stored) {
                collect(stored.value(), mentioned);
            }
        }
        return mentioned;
    }

    private static void collect(Expression e, Set<Value> values) {
        e.visit(
                each -> {
                    if (each instanceof Expression.Constant constant) {
                        values.add(constant.value());
                    }
                });
    }
}
