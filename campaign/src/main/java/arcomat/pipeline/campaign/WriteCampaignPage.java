package arcomat.pipeline.campaign;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.file.ReportPage;
import arcomat.report.campaign.CampaignJson;
import arcomat.report.campaign.CampaignPage;
import arcomat.report.campaign.CampaignReport;

import java.io.IOException;

/**
 * Writes the page of a campaign and, beside it, the same for programs.
 *
 * @param folder of the page, as the user wrote it
 */
public record WriteCampaignPage(CampaignReport report, String folder) implements Task<String> {
    private static final String RESULT = "campaign.json";

    /**
     * Returns the path of the page.
     *
     * @throws WrongUse where the folder is somebody else's, or cannot be written
     */
    @Override
    public String run(Session session) throws WrongUse {
        new ReportPage(folder, session.names()).write(CampaignPage.render(report));
        try {
            AtomicFile.write(
                    session.names().resolve(folder).resolve(RESULT), CampaignJson.render(report));
        } catch (IOException e) {
            throw Failures.cannot("write to", folder, e);
        }
        return folder + "/" + ReportPage.NAME;
    }
}
