package arcomat.report.brick;

import arcomat.sim.device.MotorName;
import arcomat.sim.device.SensorName;
import arcomat.sim.trace.Cycle;
import arcomat.sim.trace.Event;
import arcomat.sim.trace.Trace;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What a program did with its brick, cycle by cycle: what it last read and told its motors, and
 * what else happened. Sockets that nothing uses have no column.
 *
 * @param sensors those that were read
 * @param motors those that were told something
 */
record BrickRows(Set<SensorName> sensors, Set<MotorName> motors, List<Row> rows) {
    private static final long MILLISECOND = 1000;

    /**
     * A cycle.
     *
     * @param time its begin in milliseconds since switching on
     * @param read the last value of each sensor so far
     * @param told the last order of each motor so far
     * @param other what happened besides, in words
     */
    record Row(
            long time,
            Map<SensorName, Integer> read,
            Map<MotorName, Event.MotorOrdered> told,
            List<String> other) {

        /** The last value of a sensor; empty before the first. */
        String value(SensorName sensor) {
            return read.containsKey(sensor) ? read.get(sensor).toString() : "";
        }

        /** {@code 360}, {@code stop}, {@code to 90}: the last order of a motor; or empty. */
        String order(MotorName motor) {
            Event.MotorOrdered order = told.get(motor);
            if (order == null) {
                return "";
            }
            return switch (order.order()) {
                case TURN -> String.valueOf(order.value());
                case TURN_TO -> "to " + order.value();
                case POWER -> "power " + order.value();
                case STOP -> "stop";
                case FLOAT -> "float";
            };
        }

        /** What happened besides, as one text. */
        String others() {
            return String.join("; ", other);
        }

        /** Whether somebody who reads row after row learns something new. */
        boolean differsFrom(Row before) {
            return !other.isEmpty() || !read.equals(before.read) || !told.equals(before.told);
        }
    }

    static BrickRows of(Trace trace) {
        Map<SensorName, Integer> read = new EnumMap<>(SensorName.class);
        Map<MotorName, Event.MotorOrdered> told = new EnumMap<>(MotorName.class);
        List<Row> rows = new ArrayList<>();
        for (Cycle cycle : trace.cycles()) {
            read.putAll(cycle.read());
            cycle.orders().forEach(order -> told.put(order.motor(), order));
            rows.add(
                    new Row(
                            cycle.start() / MILLISECOND,
                            Map.copyOf(read),
                            Map.copyOf(told),
                            cycle.events().stream()
                                    .map(Event::besides)
                                    .filter(text -> !text.isEmpty())
                                    .toList()));
        }
        return new BrickRows(read.keySet(), told.keySet(), rows);
    }

    /** Headings of columns. */
    List<String> headings() {
        List<String> headings = new ArrayList<>(List.of("ms"));
        sensors.forEach(sensor -> headings.add(sensor.name()));
        motors.forEach(motor -> headings.add(motor.name()));
        headings.add("");
        return headings;
    }

    /** A row's cells, as many as there are headings. */
    List<String> cells(Row row) {
        List<String> cells = new ArrayList<>(List.of(String.valueOf(row.time())));
        sensors.forEach(sensor -> cells.add(row.value(sensor)));
        motors.forEach(motor -> cells.add(row.order(motor)));
        cells.add(row.others());
        return cells;
    }
}
