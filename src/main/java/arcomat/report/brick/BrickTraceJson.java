package arcomat.report.brick;

import arcomat.report.text.Json;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.SensorName;
import arcomat.sim.trace.Event;
import arcomat.sim.trace.Trace;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** A program's run for programs: a list of cycles. */
public record BrickTraceJson(List<Cycle> cycles) {
    record Cycle(
            long time,
            Map<SensorName, Integer> sensors,
            Map<MotorName, Order> motors,
            List<String> other) {
        static Cycle of(BrickRows.Row row) {
            Map<SensorName, Integer> sensors = new EnumMap<>(SensorName.class);
            sensors.putAll(row.read());
            Map<MotorName, Order> motors = new EnumMap<>(MotorName.class);
            row.told().forEach((motor, order) -> motors.put(motor, Order.of(order)));
            return new Cycle(row.time(), sensors, motors, row.other());
        }
    }

    record Order(String order, int value) {
        static Order of(Event.MotorOrdered told) {
            return new Order(told.order().name(), told.value());
        }
    }

    public static String render(Trace trace) {
        return Json.text(
                new BrickTraceJson(BrickRows.of(trace).rows().stream().map(Cycle::of).toList()));
    }
}
