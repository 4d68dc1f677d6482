package arcomat.pipeline.campaign.parquet;

import org.apache.parquet.format.ColumnChunk;
import org.apache.parquet.format.ColumnMetaData;
import org.apache.parquet.format.Encoding;
import org.apache.parquet.format.FileMetaData;
import org.apache.parquet.format.PageEncodingStats;
import org.apache.parquet.format.RowGroup;
import org.apache.parquet.format.Util;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * What stands at the end of a file of Parquet. The library lists the encodings of a column in the
 * order of a hash table of objects, which is another one in another process; it says nothing, so
 * they are put into the order of their numbers.
 */
final class Footer {
    /** The length of the footer, in four bytes with the lowest first, and four letters. */
    private static final int TAIL = 8;

    private static final Comparator<PageEncodingStats> BY_NUMBERS =
            Comparator.comparing((PageEncodingStats each) -> each.getPage_type())
                    .thenComparing(each -> each.getEncoding());

    private Footer() {}

    static void order(Path file) throws IOException {
        try (RandomAccessFile bytes = new RandomAccessFile(file.toFile(), "rw")) {
            long end = bytes.length() - TAIL;
            bytes.seek(end);
            int length = Integer.reverseBytes(bytes.readInt());
            byte[] letters = new byte[TAIL - Integer.BYTES];
            bytes.readFully(letters);
            byte[] footer = new byte[length];
            bytes.seek(end - length);
            bytes.readFully(footer);
            bytes.seek(end - length);
            byte[] ordered = ordered(footer);
            bytes.write(ordered);
            bytes.writeInt(Integer.reverseBytes(ordered.length));
            bytes.write(letters);
            bytes.setLength(bytes.getFilePointer());
        }
    }

    private static byte[] ordered(byte[] footer) throws IOException {
        FileMetaData data = Util.readFileMetaData(new ByteArrayInputStream(footer));
        for (RowGroup group : data.getRow_groups()) {
            for (ColumnChunk column : group.getColumns()) {
                order(column.getMeta_data());
            }
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream(footer.length);
        Util.writeFileMetaData(data, out);
        return out.toByteArray();
    }

    private static void order(ColumnMetaData column) {
        List<Encoding> encodings = new ArrayList<>(column.getEncodings());
        encodings.sort(Comparator.naturalOrder());
        column.setEncodings(encodings);
        if (column.isSetEncoding_stats()) {
            List<PageEncodingStats> pages = new ArrayList<>(column.getEncoding_stats());
            pages.sort(BY_NUMBERS);
            column.setEncoding_stats(pages);
        }
    }
}
