/** The live page of models: the page that lies in the installation, with the models in it. */
package arcomat.pipeline.live;
