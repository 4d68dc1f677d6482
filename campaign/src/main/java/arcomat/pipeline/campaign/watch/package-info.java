/** Programs of a campaign that watch themselves for requirements of their models. */
package arcomat.pipeline.campaign.watch;
