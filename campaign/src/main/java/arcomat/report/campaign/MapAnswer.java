package arcomat.report.campaign;

import arcomat.campaign.overview.Axis;
import arcomat.campaign.overview.HeatMap;
import arcomat.campaign.overview.HeatMap.Cell;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.stream.Stream;

/**
 * A map as the page reads it.
 *
 * @param x the parameter across, with the labels of its places in {@code columns}
 * @param y the one upwards; empty where there is none
 * @param runs of each cell, row by row
 * @param layers for each column of the table
 */
record MapAnswer(
        String x,
        String y,
        List<String> columns,
        List<String> rows,
        List<Long> runs,
        List<Layer> layers) {
    private static final MathContext DIGITS = new MathContext(4);

    /**
     * A column of the table.
     *
     * @param cells for each cell of the map how many runs have a number, and then the least, the
     *     mean and the greatest; all in one list, because there are many, and 0 where there is none
     */
    record Layer(String name, String meaning, boolean event, List<Number> cells) {}

    static MapAnswer of(HeatMap map) {
        Axis across = map.across();
        return new MapAnswer(
                across.parameter(),
                map.up().parameter(),
                across.labels(),
                map.up().labels(),
                map.runs(),
                map.layers().stream().map(MapAnswer::of).toList());
    }

    private static Layer of(HeatMap.Layer layer) {
        List<Number> cells =
                layer.cells().stream()
                        .flatMap(
                                cell ->
                                        Stream.<Number>of(
                                                cell.known(),
                                                rounded(cell, cell.least()),
                                                rounded(cell, cell.mean()),
                                                rounded(cell, cell.greatest())))
                        .toList();
        return new Layer(
                layer.column().name(), layer.column().meaning(), layer.column().isEvent(), cells);
    }

    private static Number rounded(Cell cell, double number) {
        return cell.known() == 0 ? 0 : new BigDecimal(number).round(DIGITS).doubleValue();
    }
}
