package arcomat.campaign.overview;

import arcomat.campaign.Column;
import arcomat.campaign.Row;

import java.util.ArrayList;
import java.util.List;

/**
 * Runs by the values of two parameters.
 *
 * @param runs those that were made in each cell: row by row, the first row is that of the first
 *     label of {@code up}
 * @param layers what they say, for each column of the table
 */
public record HeatMap(Axis across, Axis up, List<Long> runs, List<Layer> layers) {
    public HeatMap {
        runs = List.copyOf(runs);
        layers = List.copyOf(layers);
    }

    /**
     * A column of the table in each cell.
     *
     * @param cells in the order of {@link HeatMap#runs}
     */
    public record Layer(Column column, List<Cell> cells) {
        public Layer {
            cells = List.copyOf(cells);
        }
    }

    /**
     * The finite numbers of a cell; those of an event are 1 and 0.
     *
     * @param known how many there are
     * @param least not a number where there is none, and so are the others
     */
    public record Cell(long known, double least, double mean, double greatest) {}

    /** Counts, row by row. */
    static final class Count {
        private final List<Column> columns;
        private final Axis across;
        private final Axis up;
        private final long[] runs;
        private final List<List<Sum>> sums = new ArrayList<>();

        Count(List<Column> columns, Axis across, Axis up) {
            this.columns = columns;
            this.across = across;
            this.up = up;
            this.runs = new long[across.labels().size() * up.labels().size()];
            for (int i = 0; i < columns.size(); i++) {
                List<Sum> cells = new ArrayList<>();
                for (int cell = 0; cell < runs.length; cell++) {
                    cells.add(new Sum());
                }
                sums.add(cells);
            }
        }

        /** A run that was made. */
        void see(Row row) {
            int cell = place(up, row) * across.labels().size() + place(across, row);
            runs[cell]++;
            for (int i = 0; i < columns.size(); i++) {
                sums.get(i).get(cell).see(row.answer(i));
            }
        }

        private static int place(Axis axis, Row row) {
            return axis.place(row.trial().values().getOrDefault(axis.parameter(), ""));
        }

        HeatMap map() {
            List<Layer> layers = new ArrayList<>();
            for (int i = 0; i < columns.size(); i++) {
                layers.add(new Layer(columns.get(i), sums.get(i).stream().map(Sum::cell).toList()));
            }
            return new HeatMap(across, up, java.util.Arrays.stream(runs).boxed().toList(), layers);
        }
    }

    private static final class Sum {
        private long known;
        private double sum;
        private double least = Double.POSITIVE_INFINITY;
        private double greatest = Double.NEGATIVE_INFINITY;

        void see(double number) {
            if (Double.isFinite(number)) {
                known++;
                sum += number;
                least = Math.min(least, number);
                greatest = Math.max(greatest, number);
            }
        }

        Cell cell() {
            return known == 0
                    ? new Cell(0, Double.NaN, Double.NaN, Double.NaN)
                    : new Cell(known, least, sum / known, greatest);
        }
    }
}
