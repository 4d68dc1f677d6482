package arcomat.pipeline.campaign.parquet;

import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.BINARY;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.BOOLEAN;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.DOUBLE;
import static org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName.INT64;

import arcomat.campaign.Campaign;
import arcomat.campaign.Column;
import arcomat.campaign.Row;
import arcomat.campaign.TableText;
import arcomat.campaign.Variation;

import org.apache.parquet.io.api.Binary;
import org.apache.parquet.io.api.RecordConsumer;
import org.apache.parquet.schema.LogicalTypeAnnotation;
import org.apache.parquet.schema.Type;
import org.apache.parquet.schema.Types;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.function.ToLongFunction;
import java.util.regex.Pattern;

/**
 * A column of a table with its type.
 *
 * @param isKnown whether a row has a value there; null is written where it has none
 * @param cell writes the value of a row that has one
 */
record TypedColumn(Type type, Predicate<Row> isKnown, Cell cell) {
    private static final Pattern NUMBER = Pattern.compile("-?\\d{1,15}(\\.\\d+)?");

    /** A value on its way to the library. */
    interface Cell {
        void write(Row row, RecordConsumer out);
    }

    /** Those of {@link TableText}, in its order and with its names. */
    static List<TypedColumn> of(Campaign campaign) {
        List<TypedColumn> all = new ArrayList<>();
        all.add(whole("run", row -> row.trial().number()));
        all.add(whole("seed", row -> row.trial().seed()));
        TableText text = new TableText(campaign);
        campaign.variations().forEach(each -> all.add(ofParameter(each, text.column(each))));
        all.add(text("ending", TableText::ending));
        List<Column> answers = campaign.columns();
        for (int i = 0; i < answers.size(); i++) {
            all.add(ofAnswer(answers.get(i), i));
        }
        all.add(taken());
        return all;
    }

    private static TypedColumn taken() {
        Type type =
                Types.optional(BINARY)
                        .as(LogicalTypeAnnotation.stringType())
                        .named(TableText.TAKEN);
        return new TypedColumn(
                type,
                row -> row.reached().isKnown(),
                (row, out) -> out.addBinary(Binary.fromString(row.reached().text())));
    }

    private static TypedColumn ofParameter(Variation variation, String name) {
        String parameter = variation.parameter();
        Function<Row, String> value = row -> row.trial().values().getOrDefault(parameter, "");
        return isNumber(variation)
                ? number(name, row -> true, row -> Double.parseDouble(value.apply(row)))
                : text(name, value);
    }

    private static boolean isNumber(Variation variation) {
        return variation
                .domain()
                .match(
                        range -> true,
                        choice ->
                                choice.words().stream()
                                        .allMatch(word -> NUMBER.matcher(word).matches()));
    }

    private static TypedColumn ofAnswer(Column column, int place) {
        if (column.isEvent()) {
            Type type = Types.optional(BOOLEAN).named(column.name());
            return new TypedColumn(
                    type,
                    row -> row.answers(place),
                    (row, out) -> out.addBoolean(row.happened(place)));
        }
        return number(column.name(), row -> row.answers(place), row -> row.answer(place));
    }

    private static TypedColumn whole(String name, ToLongFunction<Row> value) {
        Type type = Types.required(INT64).named(name);
        return new TypedColumn(
                type, row -> true, (row, out) -> out.addLong(value.applyAsLong(row)));
    }

    private static TypedColumn number(
            String name, Predicate<Row> isKnown, ToDoubleFunction<Row> value) {
        Type type = Types.optional(DOUBLE).named(name);
        return new TypedColumn(
                type, isKnown, (row, out) -> out.addDouble(value.applyAsDouble(row)));
    }

    private static TypedColumn text(String name, Function<Row, String> value) {
        Type type = Types.required(BINARY).as(LogicalTypeAnnotation.stringType()).named(name);
        return new TypedColumn(
                type,
                row -> true,
                (row, out) -> out.addBinary(Binary.fromString(value.apply(row))));
    }
}
