package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Aside;
import arcomat.sim.load.Program;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Map;

/**
 * The programs of all runs of a campaign: those of every word and every step that its parameters
 * can have.
 */
record CampaignPrograms(
        Map<String, Program> programs, List<Diagnostic> findings, int files, Aside aside) {}
