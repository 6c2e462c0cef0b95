"""Pictures of a plan and of what it is compared with, as SVG and PNG; the only room that knows matplotlib."""
