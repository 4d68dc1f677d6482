/**
 * Who makes the runs of a campaign: threads of this process, or other processes on this machine or
 * on many. An engine is given content, not paths, and numbered trials; it gives back rows in any
 * order. Engines from outside are found as services.
 */
package arcomat.pipeline.campaign.engine;
