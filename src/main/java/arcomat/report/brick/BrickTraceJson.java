package arcomat.report.brick;

import arcomat.report.text.Json;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.SensorName;
import arcomat.sim.trace.Event;
import arcomat.sim.trace.Trace;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;

/** A program's run for programs: a list of cycles. */
public final class BrickTraceJson {
    private BrickTraceJson() {}

    public static String render(Trace trace) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeArrayFieldStart("cycles");
                    for (BrickRows.Row row : BrickRows.of(trace).rows()) {
                        write(json, row);
                    }
                    json.writeEndArray();
                    json.writeEndObject();
                });
    }

    private static void write(JsonGenerator json, BrickRows.Row row) throws IOException {
        json.writeStartObject();
        json.writeNumberField("time", row.time());
        json.writeObjectFieldStart("sensors");
        for (SensorName sensor : SensorName.values()) {
            Integer value = row.read().get(sensor);
            if (value != null) {
                json.writeNumberField(sensor.name(), value);
            }
        }
        json.writeEndObject();
        json.writeObjectFieldStart("motors");
        for (MotorName motor : MotorName.values()) {
            Event.MotorOrdered order = row.told().get(motor);
            if (order != null) {
                write(json, order);
            }
        }
        json.writeEndObject();
        Json.strings(json, "other", row.other());
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Event.MotorOrdered order) throws IOException {
        json.writeObjectFieldStart(order.motor().name());
        json.writeStringField("order", order.order().name());
        json.writeNumberField("value", order.value());
        json.writeEndObject();
    }
}
