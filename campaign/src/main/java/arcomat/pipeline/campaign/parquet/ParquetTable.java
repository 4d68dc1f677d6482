package arcomat.pipeline.campaign.parquet;

import arcomat.campaign.Campaign;
import arcomat.campaign.Row;

import org.apache.hadoop.conf.Configuration;
import org.apache.parquet.conf.ParquetConfiguration;
import org.apache.parquet.conf.PlainParquetConfiguration;
import org.apache.parquet.hadoop.ParquetFileWriter;
import org.apache.parquet.hadoop.ParquetWriter;
import org.apache.parquet.hadoop.api.WriteSupport;
import org.apache.parquet.hadoop.metadata.CompressionCodecName;
import org.apache.parquet.io.LocalOutputFile;
import org.apache.parquet.io.OutputFile;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;

/**
 * Writes the rows of a campaign as a Parquet file: what the table of comma-separated values says,
 * by columns, with types. The same rows give the same bytes.
 */
public final class ParquetTable {
    /** Bytes of rows that are kept until they are written together. */
    private static final long GROUP = 4L << 20;

    private ParquetTable() {}

    /**
     * @param file the one that is made; one that is there is written over
     * @param rows in the order of their numbers; taken one after the other
     */
    public static void write(Path file, Campaign campaign, Stream<Row> rows) throws IOException {
        // Not compressed: each Java has a compressor of its own, and other bytes.
        try (ParquetWriter<Row> writer =
                new Builder(new LocalOutputFile(file), TypedColumn.of(campaign))
                        .withConf(new PlainParquetConfiguration())
                        .withWriteMode(ParquetFileWriter.Mode.OVERWRITE)
                        .withCompressionCodec(CompressionCodecName.UNCOMPRESSED)
                        .withRowGroupSize(GROUP)
                        .build()) {
            for (Iterator<Row> each = rows.iterator(); each.hasNext(); ) {
                writer.write(each.next());
            }
        }
        Footer.order(file);
    }

    private static final class Builder extends ParquetWriter.Builder<Row, Builder> {
        private final List<TypedColumn> columns;

        Builder(OutputFile file, List<TypedColumn> columns) {
            super(file);
            this.columns = columns;
        }

        @Override
        protected Builder self() {
            return this;
        }

        /** Still asked for by the library's type; called by nobody who has no Hadoop. */
        @Override
        @SuppressWarnings("deprecation")
        protected WriteSupport<Row> getWriteSupport(Configuration hadoop) {
            return new RowSupport(columns);
        }

        @Override
        protected WriteSupport<Row> getWriteSupport(ParquetConfiguration configuration) {
            return new RowSupport(columns);
        }
    }
}
