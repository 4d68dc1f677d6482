package arcomat.pipeline.campaign.parquet;

import arcomat.campaign.Row;

import org.apache.hadoop.conf.Configuration;
import org.apache.parquet.conf.ParquetConfiguration;
import org.apache.parquet.hadoop.api.WriteSupport;
import org.apache.parquet.io.api.RecordConsumer;
import org.apache.parquet.schema.MessageType;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Gives a row to the library, column by column. */
final class RowSupport extends WriteSupport<Row> {
    private final List<TypedColumn> columns;
    private @Nullable RecordConsumer consumer;

    RowSupport(List<TypedColumn> columns) {
        this.columns = columns;
    }

    /** Still asked for by the library's type; called by nobody who has no Hadoop. */
    @Override
    @SuppressWarnings("deprecation")
    public WriteContext init(Configuration hadoop) {
        return context();
    }

    @Override
    public WriteContext init(ParquetConfiguration configuration) {
        return context();
    }

    private WriteContext context() {
        MessageType schema =
                new MessageType("rows", columns.stream().map(TypedColumn::type).toList());
        return new WriteContext(schema, Map.of());
    }

    @Override
    public void prepareForWrite(RecordConsumer given) {
        consumer = given;
    }

    @Override
    public void write(Row row) {
        RecordConsumer out = Objects.requireNonNull(consumer);
        out.startMessage();
        for (int i = 0; i < columns.size(); i++) {
            TypedColumn column = columns.get(i);
            if (column.isKnown().test(row)) {
                out.startField(column.type().getName(), i);
                column.cell().write(row, out);
                out.endField(column.type().getName(), i);
            }
        }
        out.endMessage();
    }
}
