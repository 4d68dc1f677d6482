package arcomat.report.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Column;
import arcomat.campaign.Row;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What a run has answered, by names.
 *
 * @param events that happened
 * @param measures finite ones
 */
record RowAnswers(List<String> events, Map<String, Double> measures) {
    static RowAnswers of(Row row, Campaign campaign) {
        List<String> events = new ArrayList<>();
        Map<String, Double> measures = new LinkedHashMap<>();
        List<Column> columns = campaign.columns();
        for (int i = 0; i < row.answers().size(); i++) {
            if (columns.get(i).isEvent()) {
                if (row.happened(i)) {
                    events.add(columns.get(i).name());
                }
            } else if (Double.isFinite(row.answer(i))) {
                measures.put(columns.get(i).name(), row.answer(i));
            }
        }
        return new RowAnswers(events, measures);
    }
}
