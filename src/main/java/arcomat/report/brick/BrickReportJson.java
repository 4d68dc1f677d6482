package arcomat.report.brick;

import arcomat.brick.BrickReport;
import arcomat.brick.api.BrickCost;
import arcomat.brick.need.Need;
import arcomat.brick.need.Needs;
import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.Locale;
import java.util.OptionalLong;

/** For programs: whether a robot's jar fits, and how full the brick will be. */
public final class BrickReportJson {
    private static final long MILLISECOND = 1000;

    private BrickReportJson() {}

    public static String render(BrickReport report) {
        return Json.text(
                json -> {
                    json.writeStartObject();
                    json.writeBooleanField("fits", report.fits());
                    FindingsJson.write(json, "findings", report.findings());
                    writeShares(json, report);
                    writeNeeds(json, report.needs());
                    json.writeEndObject();
                });
    }

    private static void writeShares(JsonGenerator json, BrickReport report) throws IOException {
        json.writeArrayFieldStart("jar");
        for (BrickReport.Share share : report.shares()) {
            json.writeStartObject();
            String origin = share.origin().name().toLowerCase(Locale.ROOT).replace('_', ' ');
            json.writeStringField("origin", origin);
            json.writeNumberField("classes", share.classes());
            json.writeNumberField("methods", share.methods());
            json.writeNumberField("bytes", share.bytes());
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    private static void writeNeeds(JsonGenerator json, Needs needs) throws IOException {
        json.writeObjectFieldStart("classes");
        json.writeNumberField("number", needs.classes());
        json.writeBooleanField("exact", needs.isExact());
        json.writeNumberField("limit", BrickReport.CLASSES);
        json.writeEndObject();
        write(json, "memory", "bytes", needs.memory(), OptionalLong.of(BrickCost.HEAP_BYTES));
        OptionalLong cycle =
                needs.cycle().isPresent()
                        ? OptionalLong.of(needs.cycle().getAsInt() * MILLISECOND)
                        : OptionalLong.empty();
        write(json, "slice", "microseconds", needs.slice(), cycle);
    }

    private static void write(
            JsonGenerator json, String field, String unit, Need need, OptionalLong limit)
            throws IOException {
        json.writeObjectFieldStart(field);
        if (need.amount().isPresent()) {
            json.writeNumberField(unit, need.amount().getAsLong());
        } else {
            json.writeStringField("unknown", need.unknown().orElseThrow());
        }
        if (limit.isPresent()) {
            json.writeNumberField("limit", limit.getAsLong());
        }
        json.writeEndObject();
    }
}
